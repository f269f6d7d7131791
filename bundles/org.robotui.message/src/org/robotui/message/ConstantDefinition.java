package org.robotui.message;

/**
 * One constant of a message definition.
 *
 * @param type the built-in type
 * @param name the name
 * @param value the value as written; for strings everything right of the equals sign, {@code #} included
 */
public record ConstantDefinition(Primitive type, String name, String value) {}
