package org.robotui.api.host;

import java.util.List;
import org.robotui.api.port.Arity;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;

/**
 * What matching says of one port of a view.
 *
 * @param port the view's port
 * @param kind what passes through
 * @param typeName the type that the view wants or gives
 * @param arity how many connections it takes
 * @param state the result
 * @param peers the connected ports
 * @param candidates the ports that would fit, where the state is ambiguous
 * @param reason a sentence for users: why it is so and what would help
 */
public record Match(
    SourceId port,
    PortKind kind,
    String typeName,
    Arity arity,
    MatchState state,
    List<SourceId> peers,
    List<SourceId> candidates,
    String reason) {}
