package org.robotui.headless.internal;

import java.io.PrintStream;
import java.nio.file.Path;

/** {@code ./robotui stop}: a process of its own that needs nothing but a Java, and starts no framework. */
public final class StopMain {
  private StopMain() {}

  /**
   * Stops all robots of all workbenches of this user, and ends with what came of it.
   *
   * @param arguments the state folder
   */
  public static void main(String[] arguments) {
    PrintStream out = System.out;
    System.exit(new StopClient(Path.of(arguments[0]), out).stop().code());
  }
}
