package org.robotui.uic.scene3d.internal.camera;

import java.util.Arrays;
import java.util.Optional;

/** How a camera is moved. */
public enum CameraKind {
  /** Around a point that is looked at. */
  ORBIT("orbit", "Orbit"),
  /** As one walks: the eye stands, and turns. */
  FLY("fly", "Fly"),
  /** From above, without perspective. */
  TOP("top", "Top down");

  private final String word;
  private final String label;

  CameraKind(String word, String label) {
    this.word = word;
    this.label = label;
  }

  /** The word in settings. */
  public String word() {
    return word;
  }

  /** The name for users. */
  public String label() {
    return label;
  }

  /** Finds the kind of a word. */
  public static Optional<CameraKind> of(String word) {
    return Arrays.stream(values()).filter(k -> k.word.equals(word)).findFirst();
  }
}
