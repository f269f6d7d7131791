package org.robotui.smartsoft.client;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.message.CdrReader;
import org.robotui.message.MessageException;
import org.robotui.net.call.OpenQuestions;
import org.robotui.smartsoft.internal.PatternData;
import org.robotui.smartsoft.internal.PatternLink;
import org.robotui.smartsoft.naming.ServiceAddress;
import org.robotui.smartsoft.wire.LinkOptions;
import org.robotui.smartsoft.wire.SmartCommand;
import org.robotui.smartsoft.wire.SmartFrame;

/** A client of push: newest, or timed where the server has a period. */
public final class PushClient implements PatternClient {

  private final Listener listener;
  private final PatternLink link;
  private final AtomicInteger subscriptions = new AtomicInteger();
  private final OpenQuestions<PushInfo> questions = new OpenQuestions<>();
  private final Queue<Integer> asked = new ConcurrentLinkedQueue<>();
  private volatile int current;

  /** Takes what a server says, on the reading thread; must not block. */
  public interface Listener {

    /**
     * An update has come.
     *
     * @param object its bytes, in their order
     */
    void updated(ByteBuffer object);

    /**
     * The server was started or stopped; timed servers say so.
     *
     * @param active whether updates come
     */
    default void activated(boolean active) {}

    /**
     * The connection has ended.
     *
     * @param reason for users
     */
    default void ended(String reason) {}
  }

  private PushClient(ServiceAddress address, LinkOptions options, Listener listener) throws IOException {
    this.listener = listener;
    this.link = PatternLink.connect(address, options, new FromServer());
  }

  /**
   * Connects to a service; blocks.
   *
   * @param address of the service
   * @param options how to be linked
   * @param listener takes updates
   * @return not subscribed yet
   * @throws IOException where it is not reached, or does not take us
   */
  public static PushClient connect(ServiceAddress address, LinkOptions options, Listener listener)
      throws IOException {
    return new PushClient(address, options, listener);
  }

  /**
   * Asks for updates, in place of a subscription that there was.
   *
   * @param every 1 for all of them, n for every n-th
   * @return false where the connection has ended
   */
  public synchronized boolean subscribe(int every) {
    unsubscribe();
    current = subscriptions.incrementAndGet();
    return link.send(SmartFrame.of(SmartCommand.SUBSCRIBE, PatternData.of().i32(every).i32(current).end()));
  }

  /** Asks for no more updates. */
  public synchronized void unsubscribe() {
    if (current > 0) {
      current = 0;
      link.send(SmartFrame.of(SmartCommand.UNSUBSCRIBE));
    }
  }

  /**
   * Asks a timed server for its period; blocks.
   *
   * @param patience how long the answer may take
   * @return its answer
   * @throws IOException where none comes
   */
  public PushInfo info(Duration patience) throws IOException {
    return questions.ask("the period", patience, reference -> {
      asked.add(reference);
      return link.send(SmartFrame.of(SmartCommand.GET_SERVER_INFO));
    });
  }

  private final class FromServer implements PatternLink.Listener {
    @Override
    public void said(SmartCommand command, SmartFrame frame) throws IOException {
      CdrReader said = frame.reader();
      try {
        switch (command) {
          case UPDATE -> {
            if (said.int32("subscription") == current) {
              listener.updated(frame.object());
            }
          }
          case SERVER_INFO -> informed(new PushInfo(Duration.ofMillis(said.int64("period")),
              said.int32("active") != 0));
          case ACTIVATION_STATE -> listener.activated(said.int32("active") != 0);
          default -> {}
        }
      } catch (MessageException e) {
        throw new IOException(e.getMessage(), e);
      }
    }

    private void informed(PushInfo info) {
      Integer reference = asked.poll();
      if (reference != null) {
        questions.answered(reference, info);
      }
    }

    @Override
    public void ended(String reason) {
      questions.fail(reason);
      listener.ended(reason);
    }
  }

  @Override
  public Optional<String> over() {
    return link.over();
  }

  @Override
  public void finish() {
    unsubscribe();
    link.finish();
  }

  @Override
  public void close() {
    unsubscribe();
    link.close();
  }
}
