package org.robotui.smartsoft.client;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.message.MessageException;
import org.robotui.smartsoft.internal.PatternData;
import org.robotui.smartsoft.internal.PatternLink;
import org.robotui.smartsoft.naming.ServiceAddress;
import org.robotui.smartsoft.wire.LinkOptions;
import org.robotui.smartsoft.wire.SmartCommand;
import org.robotui.smartsoft.wire.SmartFrame;

/** A client of event: it activates an event with a parameter, which the server compares with its state. */
public final class EventClient implements PatternClient {

  private final Listener listener;
  private final PatternLink link;
  private final AtomicInteger numbers = new AtomicInteger();
  private final Set<Integer> active = ConcurrentHashMap.newKeySet();

  /** Takes what a server says, on the reading thread; must not block. */
  public interface Listener {

    /**
     * An event has happened.
     *
     * @param activation by which it was activated
     * @param event its bytes, in their order
     */
    void fired(int activation, ByteBuffer event);

    /**
     * The connection has ended.
     *
     * @param reason for users
     */
    default void ended(String reason) {}
  }

  private EventClient(ServiceAddress address, LinkOptions options, Listener listener) throws IOException {
    this.listener = listener;
    this.link = PatternLink.connect(address, options, new FromServer());
  }

  /**
   * Connects to a service; blocks.
   *
   * @param address of the service
   * @param options how to be linked
   * @param listener takes events
   * @return nothing is active yet
   * @throws IOException where it is not reached, or does not take us
   */
  public static EventClient connect(ServiceAddress address, LinkOptions options, Listener listener)
      throws IOException {
    return new EventClient(address, options, listener);
  }

  /**
   * Activates an event.
   *
   * @param mode how often it may happen
   * @param parameter little endian
   * @return the number of the activation; empty where the connection has ended
   */
  public Optional<Integer> activate(EventMode mode, ByteBuffer parameter) {
    int number = numbers.incrementAndGet();
    active.add(number);
    boolean sent =
        link.send(SmartFrame.of(SmartCommand.ACTIVATE, PatternData.of().i32(mode.ordinal()).i64(number).end(),
            parameter));
    return sent ? Optional.of(number) : Optional.empty();
  }

  /**
   * Deactivates an event.
   *
   * @param activation its number; one that is not active is left as it is
   */
  public void deactivate(int activation) {
    if (active.remove(activation)) {
      link.send(SmartFrame.of(SmartCommand.DEACTIVATE, PatternData.of().i64(activation).end()));
    }
  }

  private final class FromServer implements PatternLink.Listener {
    @Override
    public void said(SmartCommand command, SmartFrame frame) throws IOException {
      if (command == SmartCommand.EVENT) {
        try {
          int number = (int) frame.reader().int64("activation");
          if (active.contains(number)) {
            listener.fired(number, frame.object());
          }
        } catch (MessageException e) {
          throw new IOException(e.getMessage(), e);
        }
      }
    }

    @Override
    public void ended(String reason) {
      listener.ended(reason);
    }
  }

  @Override
  public Optional<String> over() {
    return link.over();
  }

  @Override
  public void finish() {
    active.forEach(this::deactivate);
    link.finish();
  }

  @Override
  public void close() {
    active.forEach(this::deactivate);
    link.close();
  }
}
