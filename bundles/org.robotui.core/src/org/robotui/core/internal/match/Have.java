package org.robotui.core.internal.match;

import org.robotui.api.port.Port;
import org.robotui.api.port.SourceId;

/**
 * A port that a robot interface offers.
 *
 * @param id which
 * @param port as offered
 */
public record Have(SourceId id, Port port) {}
