package org.robotui.api.host;

import java.util.List;
import org.robotui.api.link.LinkState;

/**
 * How a RUIC is doing, at one moment. Cheap enough to ask for ten times a second.
 *
 * @param name the RUIC
 * @param state its life cycle
 * @param reason a sentence for users where it failed, else empty
 * @param link the worst link of its robot interfaces
 * @param components all components
 * @param ports all ports of its robot interfaces, sorted by kind and name
 * @param matches what matching says of every port of its views
 */
public record RuicSnapshot(
    String name,
    RuicState state,
    String reason,
    LinkState link,
    List<ComponentStatus> components,
    List<PortStatus> ports,
    List<Match> matches) {}
