package org.robotui.ros.reconfigure;

/**
 * One of the values a parameter is meant to have.
 *
 * @param name its name for a user
 * @param value the value
 * @param description for a user; may be empty
 */
public record ConfigChoice(String name, ConfigValue value, String description) {}
