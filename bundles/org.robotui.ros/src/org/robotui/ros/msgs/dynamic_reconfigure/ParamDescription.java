package org.robotui.ros.msgs.dynamic_reconfigure;

import org.robotui.message.MessageType;

/**
 * Describes a parameter ({@code dynamic_reconfigure/ParamDescription}).
 *
 * @param name the parameter
 * @param type {@code bool}, {@code int}, {@code double} or {@code str}
 * @param level bits the server hears of when it changes
 * @param description for a user
 * @param editMethod the choices it has, as the text of a Python dictionary; empty if it has none
 */
@MessageType("dynamic_reconfigure/ParamDescription")
public record ParamDescription(String name, String type, long level, String description, String editMethod) {}
