package org.robotui.smartsoft.client;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Optional;
import org.robotui.smartsoft.internal.PatternLink;
import org.robotui.smartsoft.naming.ServiceAddress;
import org.robotui.smartsoft.wire.LinkOptions;
import org.robotui.smartsoft.wire.SmartCommand;
import org.robotui.smartsoft.wire.SmartFrame;

/** A client of send. Nobody says whether what was sent was taken. */
public final class SendClient implements PatternClient {

  private final PatternLink link;

  private SendClient(PatternLink link) {
    this.link = link;
  }

  /**
   * Connects to a service; blocks.
   *
   * @param address of the service
   * @param options how to be linked
   * @return connected
   * @throws IOException where it is not reached, or does not take us
   */
  public static SendClient connect(ServiceAddress address, LinkOptions options) throws IOException {
    return new SendClient(PatternLink.connect(address, options, new PatternLink.Listener() {
      @Override
      public void said(SmartCommand command, SmartFrame frame) {
        // a server of send says nothing
      }

      @Override
      public void ended(String reason) {
        // who sends next is told
      }
    }));
  }

  /**
   * Sends an object in its turn.
   *
   * @param object little endian
   * @return false where the connection has ended, or too much waits
   */
  public boolean send(ByteBuffer object) {
    return link.send(SmartFrame.of(SmartCommand.COMMAND, SmartFrame.data(), object));
  }

  /**
   * Sends an object in place of one that still waits, before all else.
   *
   * @param object little endian
   * @return false where the connection has ended
   */
  public boolean replace(ByteBuffer object) {
    return link.replace("object", SmartFrame.of(SmartCommand.COMMAND, SmartFrame.data(), object));
  }

  @Override
  public Optional<String> over() {
    return link.over();
  }

  @Override
  public void finish() {
    link.finish();
  }

  @Override
  public void close() {
    link.close();
  }
}
