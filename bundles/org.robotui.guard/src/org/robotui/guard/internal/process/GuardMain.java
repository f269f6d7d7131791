package org.robotui.guard.internal.process;

import java.io.DataInputStream;
import java.io.IOException;
import java.util.Optional;
import org.robotui.guard.internal.wire.Wire;

/** The program. Its argument is the process that it guards; what it does stands in {@link Wire}. */
public final class GuardMain {
  private GuardMain() {}

  /**
   * Runs until the guarded process is gone or says goodbye.
   *
   * @param arguments the id of the guarded process
   * @throws IOException where no port can be had or the secrets do not come
   */
  public static void main(String[] arguments) throws IOException {
    Optional<ProcessHandle> guarded = ProcessHandle.of(Long.parseLong(arguments[0]));
    DataInputStream in = new DataInputStream(System.in);
    byte[] knock = in.readNBytes(Wire.SECRET);
    byte[] answer = in.readNBytes(Wire.SECRET);
    if (answer.length < Wire.SECRET) {
      throw new IOException("the secrets are missing");
    }
    LineSender voice = new LineSender(System.out);
    try (Relay relay =
        new Relay(knock, answer, Limits.standard(), voice, () -> guarded.map(ProcessHandle::isAlive).orElse(false))) {
      voice.say(Wire.PORT + relay.port());
      Thread orders = new Thread(() -> new Orders(in).follow(relay), "orders");
      orders.setDaemon(true);
      orders.start();
      relay.run();
    }
    // The thread of the orders may be in a read that nothing ends.
    Runtime.getRuntime().halt(0);
  }
}
