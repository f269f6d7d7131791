package org.robotui.uic.parameters.internal.model;

import java.util.List;
import java.util.Optional;

/**
 * The settings of one running program.
 *
 * @param server the program
 * @param knobs its settings in their order, empty before the first answer
 * @param known whether it has answered
 * @param failure why it did not answer, none where it did
 */
public record Panel(Key server, List<Knob> knobs, boolean known, Optional<String> failure) {}
