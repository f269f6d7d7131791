package org.robotui.message.roboframe;

import org.robotui.message.MessageType;

/**
 * How one module is doing ({@code roboframe/ModuleState}).
 *
 * @param name of the module
 * @param failed whether it was stopped by an error
 * @param text what it does, or why it was stopped
 * @param runs how often it has run
 */
@MessageType("roboframe/ModuleState")
public record ModuleStateStreamable(String name, boolean failed, String text, long runs) {}
