package org.robotui.core.internal.match;

import java.util.List;
import org.robotui.api.port.SourceId;

/**
 * A connection that somebody named.
 *
 * @param peers the named ports; empty where the port shall stay unconnected
 * @param by who says so, for messages: a place in a file, or the user
 */
public record Choice(List<SourceId> peers, String by) {}
