package org.robotui.recording.internal.io;

/** Bytes are not what they should be. Who knows the place in the file tells it. */
public final class MalformedRecord extends Exception {

  private static final long serialVersionUID = 1L;

  public MalformedRecord(String problem) {
    super(problem, null, false, false);
  }
}
