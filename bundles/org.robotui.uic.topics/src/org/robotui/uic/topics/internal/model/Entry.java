package org.robotui.uic.topics.internal.model;

import java.util.Optional;
import org.robotui.api.port.SourceId;

/**
 * A thing that a robot has.
 *
 * @param key which one
 * @param type the robot's name of its type, empty where not known
 * @param stream the stream that gives its messages, where there is one
 */
public record Entry(Key key, String type, Optional<SourceId> stream) {}
