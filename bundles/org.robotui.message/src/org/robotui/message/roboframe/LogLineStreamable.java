package org.robotui.message.roboframe;

import org.robotui.message.MessageType;

/**
 * What a module says to people ({@code roboframe/LogLine}).
 *
 * @param stamp when it was said, nanoseconds by the clock of the application
 * @param level 0 for developers, 1 as it should be, 2 worth a look, 3 something does not work, 4 nothing works
 * @param module who says it
 * @param text what is said
 */
@MessageType("roboframe/LogLine")
public record LogLineStreamable(long stamp, int level, String module, String text) {}
