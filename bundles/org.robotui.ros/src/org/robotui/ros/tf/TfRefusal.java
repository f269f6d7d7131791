package org.robotui.ros.tf;

/**
 * A received transform that was not taken over.
 *
 * @param topic the topic it came on
 * @param callerId the node that sent it
 * @param reason why, for a user to read
 */
public record TfRefusal(String topic, String callerId, String reason) {}
