package org.robotui.testkit.rfic;

import java.util.Optional;
import org.robotui.data.Data;
import org.robotui.data.Stamp;

/**
 * What the robot can say.
 *
 * @param port the stream by which it has to come
 * @param expected as what it has to come: in SI units, in frames of the robot {@code robby}
 * @param stamp with which stamp, none where the message carries none
 */
public record Sample(String port, Data expected, Optional<Stamp> stamp) {
  @Override
  public String toString() {
    return port;
  }
}
