package org.robotui.message;

/**
 * One field of a message definition.
 *
 * @param type the type, with message types by their full name
 * @param name the name
 */
public record FieldDefinition(FieldType type, String name) {}
