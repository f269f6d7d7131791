/**
 * JSON and CBOR as trees of plain Java values, read within bounds: {@link java.util.Map} by {@code String},
 * {@link java.util.List}, {@code String}, {@code Boolean}, {@code Long}, {@link java.math.BigInteger}, {@code Double},
 * {@code byte[]}, and {@code long[]} or {@code double[]} for arrays of nothing but numbers. What JSON calls null is
 * {@code JsonNull}, and NaN within an array of numbers.
 */
package org.robotui.web.tree;
