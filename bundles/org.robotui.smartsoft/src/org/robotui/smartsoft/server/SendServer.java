package org.robotui.smartsoft.server;

import java.io.IOException;
import java.nio.ByteBuffer;
import org.robotui.message.MessageException;
import org.robotui.smartsoft.internal.ServiceDoor;
import org.robotui.smartsoft.naming.ServiceAddress;
import org.robotui.smartsoft.wire.SmartCommand;

/** A server of send. */
public final class SendServer implements PatternServer {

  private final ServiceDoor door;

  /** Takes what clients send, on the thread of each. */
  @FunctionalInterface
  public interface Handler {

    /**
     * An object has come.
     *
     * @param object its bytes, in their order
     * @throws MessageException where they are none of this service, which ends the link of that client
     */
    void sent(ByteBuffer object) throws MessageException;
  }

  /**
   * Listens at once.
   *
   * @param options where
   * @param handler takes what is sent
   * @throws IOException where the port cannot be had
   */
  public SendServer(SmartServerOptions options, Handler handler) throws IOException {
    this.door = new ServiceDoor(options, (command, frame, client) -> {
      if (command == SmartCommand.COMMAND) {
        handler.sent(frame.object());
      }
    });
  }

  @Override
  public ServiceAddress address() {
    return door.address();
  }

  /**
   * How many are connected.
   *
   * @return clients
   */
  public int clients() {
    return door.clients().size();
  }

  @Override
  public void close() {
    door.close();
  }
}
