package org.robotui.rosbridge;

/**
 * What a bridge is asked for.
 *
 * @param most how many messages are kept here until they are taken; 1 where only the newest counts
 * @param throttleMillis the bridge sends a message at most so often, in milliseconds; 0 for all
 * @param compression {@code none} for JSON, {@code cbor}, or {@code cbor-raw} for the bytes of ROS
 */
public record SubscriptionOptions(int most, int throttleMillis, String compression) {}
