package org.robotui.uic.plot.internal.model;

import java.util.Optional;

/**
 * A signal that a plot has a name for, so that others can be made of it.
 *
 * @param name a word
 * @param signal what it means; may be wrong, and may have the names that stand before it
 * @param unit in place of the one known for the signal
 */
public record NamedSignal(String name, String signal, Optional<String> unit) {}
