package org.robotui.api.port;

import java.util.Optional;
import java.util.function.Supplier;

/**
 * What is known of a message beside its bytes, for those who keep it.
 *
 * @param topic the robot's name of the topic, channel or device that it came by; empty where it is not known
 * @param sender who sent it, as a user knows it; empty where it is not known
 * @param kept whether the robot's software keeps the sender's last message for those who come later
 * @param definition of its type, made when it is asked for, on any thread and without waiting for the robot; none where
 * it is not known, or not yet
 */
public record RawOrigin(String topic, String sender, boolean kept, Supplier<Optional<RawDefinition>> definition) {
  /** Of messages of which nothing else is known. */
  public static final RawOrigin UNKNOWN = new RawOrigin("", "", false, Optional::empty);
}
