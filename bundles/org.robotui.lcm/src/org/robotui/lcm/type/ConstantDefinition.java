package org.robotui.lcm.type;

/**
 * A named value of a struct or an enum. Constants are never sent.
 *
 * @param name its name
 * @param type a signed integer or a floating point type
 * @param value a {@link Long} or a {@link Double}, by the type
 * @param text the value as it was written
 */
public record ConstantDefinition(String name, Primitive type, Number value, String text) {}
