package org.robotui.bridge.internal.far;

import java.util.Optional;
import org.robotui.data.Data;
import org.robotui.data.Stamp;
import org.robotui.data.command.RelayMessage.Answer;
import org.robotui.data.command.RelayMessage.Original;

/**
 * A value that is ready for the other side.
 *
 * @param value with the frames and stamps of that side
 * @param stamp when it was measured, by the clock of that side
 * @param original the message that it came as
 * @param kept whether those who come later get it as well
 * @param answer hears what became of it, once
 */
public record Crossing(Data value, Optional<Stamp> stamp, Original original, boolean kept, Answer answer) {}
