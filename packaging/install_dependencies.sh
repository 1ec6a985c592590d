# shellcheck shell=bash
# To be sourced. Defines install_dependencies [LIST], which installs what is missing of the packages in packaging/LIST,
# packaging/dependencies unless one is given. When nothing is missing it needs neither network nor root.

missing_packages() {
  local list=$1 package status
  while read -r package _; do
    [[ -z $package || $package == \#* ]] && continue
    status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) || true
    [[ $status == installed ]] || echo "$package"
  done <"$list"
}

install_dependencies() {
  local list as_root=() missing=()
  list=$(dirname "${BASH_SOURCE[0]}")/${1:-dependencies}
  if ! command -v dpkg-query >/dev/null; then
    echo "This is no Debian system. Install what $list lists; going on as if it were there." >&2
    return
  fi
  mapfile -t missing < <(missing_packages "$list")
  ((${#missing[@]})) || return 0

  echo "Installing ${#missing[@]} packages: ${missing[*]}" >&2
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
      echo "Neither root nor sudo. Run as root: apt-get install --no-install-recommends ${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  # The lists of packages may be older than the archive: fetch them first, and try without should that fail.
  "${as_root[@]}" apt-get update -q >&2 || echo "The lists of packages could not be fetched; trying with those at hand." >&2
  if ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}" >&2; then
    echo "Could not install: ${missing[*]}. Is there a network, and is this Debian 12?" >&2
    return 1
  fi
}
