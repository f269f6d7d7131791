package org.robotui.player.interfaces;

import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;

/** Recording and replay at the server. The interface {@code log}. */
public final class PlayerLog {

  /** Request: set write by {@link Switch}; the answer is empty. */
  public static final Kind.Request<Switch, Empty> SET_WRITE =
      new Kind.Request<>("log", "set_write", Switch.class, Empty.class);

  /** Request: set read by {@link Switch}; the answer is empty. */
  public static final Kind.Request<Switch, Empty> SET_READ =
      new Kind.Request<>("log", "set_read", Switch.class, Empty.class);

  /** Request: get state; answered by {@link State}. */
  public static final Kind.Request<Empty, State> GET_STATE =
      new Kind.Request<>("log", "get_state", Empty.class, State.class);

  /** Request: rewind; nothing is asked with it or answered. */
  public static final Kind.Request<Empty, Empty> REWIND = new Kind.Request<>("log", "rewind", Empty.class, Empty.class);

  /** Request: set file by {@link File}; the answer is empty. */
  public static final Kind.Request<File, Empty> SET_FILE =
      new Kind.Request<>("log", "set_file", File.class, Empty.class);

  private PlayerLog() {}

  /**
   * What it does.
   *
   * @param kind 1 replays, 2 records
   * @param running whether it does now
   */
  public record State(int kind, boolean running) {}

  /**
   * Where it records to.
   *
   * @param name the file's name
   */
  public record File(String name) {}
}
