package org.robotui.uic.postures.internal.model;

import java.util.Optional;
import org.robotui.ui.Health;

/**
 * How far the robot is with its postures.
 *
 * @param target the posture that it goes to
 * @param failed the posture that it did not reach
 * @param health what to think of the words
 * @param words what is to be said; empty where nothing is
 */
record PlayerLook(Optional<Posture> target, Optional<Posture> failed, Health health, String words) {
  boolean isPlaying() {
    return target.isPresent();
  }
}
