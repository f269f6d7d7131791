package org.robotui.xbot;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.robotui.xbot.internal.Layout;
import org.robotui.xbot.internal.NativeClient;
import org.robotui.xbot.internal.Segments;

/**
 * A connection to a running control of this machine and user. All methods are safe for all threads; {@link #request}
 * blocks up to its time-out and others that talk to the supervisor wait for it, reading the state never does.
 */
public final class RtClient implements AutoCloseable {
  private static final Duration TIMEOUT = Duration.ofSeconds(2);

  private final String robot;
  private final Layout layout = Layout.shipped();
  private final Segments.Readers readers = Segments.Readers.of(layout);
  private final NativeClient client;
  private volatile Segments segments;

  private RtClient(String robot) throws IOException {
    this.robot = robot;
    this.client = NativeClient.connect(robot, TIMEOUT);
    try {
      this.segments = client.attach(readers, TIMEOUT);
    } catch (IOException e) {
      client.close();
      throw e;
    }
  }

  /**
   * Connects and attaches.
   *
   * @param robot the robot's name
   * @return the connection
   * @throws IOException with a sentence for users: no such robot runs, it is another user's, or is of another version
   */
  public static RtClient connect(String robot) throws IOException {
    return new RtClient(robot);
  }

  /**
   * Hears what the supervisor says, and maps what was replaced. To be called now and then.
   *
   * @return false where the supervisor is gone; then what is mapped stays as it was
   * @throws IOException where what was replaced cannot be mapped
   */
  public boolean refresh() throws IOException {
    return switch (client.notice()) {
      case NONE -> true;
      case CHANGED -> {
        segments = client.attach(readers, TIMEOUT);
        yield true;
      }
      case GONE -> false;
    };
  }

  /**
   * The number of the newest cycle, which is cheap to ask for.
   *
   * @return from 1; 0 before the first
   */
  public long newestCycle() {
    return segments.newestCycle();
  }

  /**
   * The newest state.
   *
   * @return none before the first cycle
   */
  public Optional<StateFrame> state() {
    return segments.state();
  }

  /**
   * Reads every cycle from now on.
   *
   * @return a reader with a place of its own, for one thread
   */
  public CycleReader cycles() {
    return new CycleReader(() -> segments);
  }

  /**
   * How the loop at the hardware keeps its time.
   *
   * @return counted since that process began
   */
  public Timing loop() {
    return segments.loop();
  }

  /**
   * What there is.
   *
   * @return none where the supervisor died while it wrote
   */
  public Optional<Board> board() {
    return segments.board();
  }

  /**
   * What the processes of plugins say.
   *
   * @return by index, as on the board
   */
  public List<HostReading> hosts() {
    return segments.hosts();
  }

  /**
   * Asks the supervisor: {@code switch P 1|0}, {@code reload P}, {@code command P WORDS}, {@code status P}.
   *
   * @param words the request
   * @param timeout how long to wait for the answer
   * @return the answer, also where none came: then not ok, with a sentence
   * @throws IOException where the connection is closed
   */
  public Answer request(String words, Duration timeout) throws IOException {
    return client.request(words, timeout);
  }

  /**
   * Becomes the master: from now on references of nobody else count.
   *
   * @param silence after how long without a reference this ends by itself
   * @return the mastership
   * @throws IOException with a sentence where it is refused
   */
  public Mastership take(Duration silence) throws IOException {
    int joints = board().map(b -> b.joints().size()).orElse(0);
    return Mastership.take(robot, layout, joints, silence);
  }

  @Override
  public void close() {
    client.close();
  }
}
