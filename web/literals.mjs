// A text as C++ source: pieces of one literal each, which a function returns.

export function literals({ made, header, function: name, text }) {
  const size = 12000;
  const pieces = [];
  for (let at = 0; at < text.length; ) {
    let end = Math.min(at + size, text.length);
    if (end < text.length && /[\uD800-\uDBFF]/.test(text[end - 1])) --end;
    const piece = text.slice(at, end);
    // With its length: a compiler gives up counting megabytes.
    pieces.push(`    {R"PAGE(${piece})PAGE", ${Buffer.byteLength(piece)}},`);
    at = end;
  }
  if (text.includes(')PAGE"')) throw new Error('the text holds the mark that ends a literal');
  return [
    `// ${made}`,
    `#include "solver/program/explore/${header}"`,
    '',
    'namespace stationary {',
    'namespace {',
    'constexpr std::string_view pieces[] = {',
    ...pieces,
    '};',
    '}  // namespace',
    `std::span<const std::string_view> ${name}() { return pieces; }`,
    '}  // namespace stationary',
    '',
  ].join('\n');
}
