package org.robotui.core.internal.match;

/**
 * A robot interface.
 *
 * @param component its id
 * @param settled true where nothing more is to be expected of it soon
 * @param status what it is doing, as a part of a sentence, for example {@code is connecting}; only where not settled
 */
public record Supplier(String component, boolean settled, String status) {}
