package org.robotui.smartsoft.client;

import java.time.Duration;

/**
 * What a timed push server says of itself.
 *
 * @param period between two updates, in milliseconds on the wire
 * @param active whether it updates now
 */
public record PushInfo(Duration period, boolean active) {}
