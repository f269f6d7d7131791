package org.robotui.smartsoft.server;

import java.io.IOException;
import java.nio.ByteBuffer;
import org.robotui.message.MessageException;
import org.robotui.smartsoft.internal.PatternData;
import org.robotui.smartsoft.internal.ServiceDoor;
import org.robotui.smartsoft.naming.ServiceAddress;
import org.robotui.smartsoft.wire.SmartCommand;
import org.robotui.smartsoft.wire.SmartFrame;

/** A server of query. */
public final class QueryServer implements PatternServer {

  private final ServiceDoor door;

  /** Answers requests, on the thread of each client. */
  @FunctionalInterface
  public interface Handler {

    /**
     * A request has come.
     *
     * @param request its bytes, in their order
     * @return the answer, little endian
     * @throws MessageException where the bytes are no request of this service, which ends the link of that client
     */
    ByteBuffer answer(ByteBuffer request) throws MessageException;
  }

  /**
   * Listens at once.
   *
   * @param options where
   * @param handler answers
   * @throws IOException where the port cannot be had
   */
  public QueryServer(SmartServerOptions options, Handler handler) throws IOException {
    this.door = new ServiceDoor(options, (command, frame, client) -> {
      if (command == SmartCommand.REQUEST) {
        long number = frame.reader().int64("query");
        client.send(
            SmartFrame.of(SmartCommand.ANSWER, PatternData.of().i64(number).end(), handler.answer(frame.object())));
      }
    });
  }

  @Override
  public ServiceAddress address() {
    return door.address();
  }

  @Override
  public void close() {
    door.close();
  }
}
