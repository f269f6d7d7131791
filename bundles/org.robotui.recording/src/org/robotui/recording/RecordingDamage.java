package org.robotui.recording;

/**
 * Something in a recording that could not be read, while the rest could.
 *
 * @param offset the byte of the file at which that begins
 * @param problem what is wrong there, and what was left out for it
 */
public record RecordingDamage(long offset, String problem) {

  @Override
  public String toString() {
    return "byte " + offset + ": " + problem;
  }
}
