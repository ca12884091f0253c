# Completion for bash. Commands and options are the program's own: they are read from its help.
_stationary() {
  local program=${COMP_WORDS[0]} word=${COMP_WORDS[COMP_CWORD]} command= i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    [[ ${COMP_WORDS[i]} == -* ]] || { command=${COMP_WORDS[i]}; break; }
  done
  COMPREPLY=()
  if [[ -z $command || $command == help ]]; then
    [[ $word == -* ]] && COMPREPLY=($(compgen -W '--help --version' -- "$word")) && return
    COMPREPLY=($(compgen -W "$("$program" help 2>/dev/null |
      sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p')" -- "$word"))
  elif [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "$("$program" help "$command" 2>/dev/null |
      grep -oE '^  (-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+')" -- "$word"))
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$word")  # a name may have spaces
  fi
}
complete -o filenames -F _stationary stationary stationary-mpi
