package org.robotui.core.internal.match;

import org.robotui.api.port.Port;
import org.robotui.api.port.SourceId;

/**
 * A port of a view that wants to be connected.
 *
 * @param id which
 * @param port as its type declares it
 */
public record Want(SourceId id, Port port) {}
