package org.robotui.player.layout;

import java.util.Optional;
import org.robotui.player.wire.MessageType;

/**
 * One message of an interface.
 *
 * @param type DATA, COMMAND, REQUEST or SYNC
 * @param subtype its number among those of its type
 * @param name its name, words with underscores
 * @param payload what it carries; empty for a message without a body
 * @param answer what the answer to a request carries; empty for none
 * @param comment what it is for; empty if the layout says nothing
 */
public record MessageLayout(
    MessageType type, int subtype, String name, Optional<StructLayout> payload, Optional<StructLayout> answer,
    String comment) {}
