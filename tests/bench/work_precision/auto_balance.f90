! The curve of the panel "curve" as AUTO-07p has it: the balance in the logarithms of the stretches
! (lib/balance), with its Jacobian, U = (ln xi, ln zeta) or (ln xi, ln zeta, ln rho), PAR(1) = nu.
! The body is read from auto_balance.dat, in the order of STPNT's read statements.
module auto_balance
  implicit none
  integer, parameter :: reciprocal_determinant = 1, neo_hookean = 2, hencky = 3
  integer :: model
  double precision :: first, second   ! coefficients of the plane
  double precision :: a, b            ! of the thickness a/rho + b rho^2/2
  double precision :: inertia(3)      ! C = nu^2 inertia: J1, J2, J3, and 0 along the axis of the spin
  double precision :: start(3)        ! at nu = 0
end module auto_balance

subroutine FUNC(NDIM, U, ICP, PAR, IJAC, F, DFDU, DFDP)
  use auto_balance
  implicit none
  integer, intent(in) :: NDIM, ICP(*), IJAC
  double precision, intent(in) :: U(NDIM), PAR(*)
  double precision, intent(out) :: F(NDIM)
  double precision, intent(inout) :: DFDU(NDIM, NDIM), DFDP(NDIM, *)
  double precision :: pull(3)  ! q_i^2 C_ii
  double precision :: square(2), mixed, own(2), rho_square, push
  integer :: i

  square = exp(2.0d0*U(1:2))
  pull(1:2) = PAR(1)**2*inertia(1:2)*square
  select case (model)
  case (reciprocal_determinant)  ! c/d + k (t^2 - 2d)/2
    mixed = first*exp(-U(1) - U(2))
    F(1:2) = second*square - mixed - pull(1:2)
    own = 2.0d0*second*square + mixed
  case (neo_hookean)
    mixed = second
    F(1:2) = first*square + second*(U(1) + U(2)) - first - pull(1:2)
    own = 2.0d0*first*square + second
  case default  ! hencky
    mixed = second
    F(1:2) = 2.0d0*first*U(1:2) + second*(U(1) + U(2)) - pull(1:2)
    own = 2.0d0*first + second
  end select
  if (NDIM == 3) then
    rho_square = exp(2.0d0*U(3))
    push = a*exp(-U(3))
    pull(3) = PAR(1)**2*inertia(3)*rho_square
    F(3) = b*rho_square - push - pull(3)
  end if
  if (IJAC == 0) return

  DFDU = 0.0d0
  do i = 1, 2
    DFDU(i, i) = own(i) - 2.0d0*pull(i)
    DFDU(i, 3 - i) = mixed
    DFDP(i, 1) = -2.0d0*PAR(1)*inertia(i)*square(i)
  end do
  if (NDIM == 3) then
    DFDU(3, 3) = 2.0d0*b*rho_square + push - 2.0d0*pull(3)
    DFDP(3, 1) = -2.0d0*PAR(1)*inertia(3)*rho_square
  end if
end subroutine FUNC

subroutine STPNT(NDIM, U, PAR, T)
  use auto_balance
  implicit none
  integer, intent(in) :: NDIM
  double precision, intent(inout) :: U(NDIM), PAR(*)
  double precision, intent(in) :: T
  integer :: unit

  open (newunit=unit, file='auto_balance.dat', status='old', action='read')
  read (unit, *) model
  read (unit, *) first, second
  read (unit, *) a, b
  read (unit, *) inertia
  read (unit, *) start
  close (unit)
  U = start(1:NDIM)
  PAR(1) = 0.0d0
end subroutine STPNT

! Of no use here, but AUTO calls for them.
subroutine BCND
end subroutine BCND

subroutine ICND
end subroutine ICND

subroutine FOPT
end subroutine FOPT

subroutine PVLS
end subroutine PVLS
