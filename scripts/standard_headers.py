"""Which header of the standard library declares which name: scripts/check_includes.py looks whether files include it.

A name in `declared` is found in each of its headers (C++20, [headers] and the synopses). Names that nearly every header
declares (std::size_t, std::move, std::pair) are not looked for.
"""

import re

declared = {
    "algorithm": "all_of any_of binary_search clamp copy copy_if copy_n count_if equal fill fill_n find find_if generate "
                 "lower_bound max max_element merge min min_element minmax minmax_element mismatch none_of nth_element "
                 "partition remove_if replace reverse rotate set_difference sort stable_sort transform unique upper_bound",
    "algorithm ranges": "ranges",
    "array": "array to_array",
    "atomic": "atomic atomic_flag atomic_ref memory_order_acquire memory_order_relaxed memory_order_release",
    "bit": "bit_cast bit_ceil bit_width countl_zero countr_zero endian popcount",
    "bitset": "bitset",
    "charconv": "from_chars to_chars",
    "chrono": "chrono",
    "cmath": "acos asin atan atan2 ceil copysign cos exp floor fma fmod hypot isfinite isinf isnan log log10 log2 lround "
             "nextafter pow remainder round sin sqrt tan trunc",
    "cmath numeric": "lerp",
    "condition_variable": "condition_variable",
    "cstdint": "int16_t int32_t int64_t int8_t uint16_t uint32_t uint64_t uint8_t",
    "cstring": "memcmp memcpy memmove memset strcmp strlen",
    "deque": "deque",
    "exception stdexcept": "current_exception exception exception_ptr rethrow_exception",
    "filesystem": "filesystem",
    "filesystem system_error": "errc error_code",
    "fstream": "fstream ifstream ofstream",
    "functional": "bind cref function invoke ref reference_wrapper",
    "initializer_list": "initializer_list",
    "iostream": "cerr cin clog cout",
    "limits": "numeric_limits",
    "list": "list",
    "map": "map multimap",
    "memory": "dynamic_pointer_cast enable_shared_from_this make_shared make_unique shared_ptr static_pointer_cast "
              "unique_ptr weak_ptr",
    "mutex": "call_once lock_guard mutex once_flag recursive_mutex scoped_lock",
    "numbers": "numbers",
    "numeric": "accumulate inner_product iota midpoint partial_sum",
    "optional": "nullopt nullopt_t optional",
    "queue": "priority_queue queue",
    "random": "mt19937 mt19937_64 normal_distribution uniform_real_distribution",
    "regex": "regex regex_match smatch",
    "set": "multiset set",
    "span": "as_bytes as_writable_bytes dynamic_extent span",
    "sstream": "istringstream ostringstream stringstream",
    "stdexcept": "invalid_argument logic_error out_of_range runtime_error",
    "string": "getline stod stoi string to_string",
    "string string_view": "string_view",
    "system_error": "system_error",
    "thread": "jthread this_thread thread",
    "tuple": "apply forward_as_tuple make_tuple tie tuple",
    "typeindex": "type_index",
    "unordered_map": "unordered_map",
    "unordered_set": "unordered_set",
    "variant": "get_if holds_alternative monostate variant visit",
    "vector": "vector",
}
headers_of = {name: frozenset(headers.split()) for headers, names in declared.items() for name in names.split()}

use = re.compile(r"\bstd::(\w+)")
text = re.compile(r'"(?:\\.|[^"\\])*"')


def missing(included, lines):
    """Yields (line number, message) of each name that is used without one of its headers; `included`: standard headers."""
    told = set()
    for number, line in enumerate(lines, 1):
        for name in use.findall(text.sub("", line).partition("//")[0]):
            headers = headers_of.get(name, frozenset())
            if headers and name not in told and not headers & included:
                told.add(name)
                yield number, f"std::{name} is named, {' or '.join(f'<{one}>' for one in sorted(headers))} not included"
