package org.robotui.testkit.rfic;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ThreadFactory;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.data.Data;
import org.robotui.data.command.Motion;

/**
 * A robot of one framework, and the robot interface to it, for {@link RficContract}. A new one is away and has its
 * address already. Its threads come from {@link Peer#THREADS}, so that those of the robot interface can be told from
 * them. All is called by one thread.
 */
public interface Peer extends AutoCloseable {
  /** Makes all threads of robots, in a group of their own. */
  ThreadFactory THREADS = Thread.ofPlatform().daemon().group(new ThreadGroup("robots of tests")).factory();

  /**
   * What it cannot be tested for.
   *
   * @return the reasons, each a sentence
   */
  Map<Capability, String> lacks();

  /**
   * Makes a robot interface to this robot, which need not be there yet.
   *
   * @param context what core gives; its robot is called {@code robby}
   * @return a new instance, not started
   */
  Rfic create(RficContext context);

  /**
   * Comes, or comes back at the same address. It drives nothing and nobody is linked to it. Returns when it is all
   * there.
   *
   * @throws IOException where it cannot
   */
  void start() throws IOException;

  /**
   * Goes without a word, as with a cut cable or a killed process: all links break.
   *
   * @throws IOException where it cannot
   */
  void kill() throws IOException;

  /** Hangs from now on: links stay, nothing is taken from them, nothing is answered or said. */
  void hang();

  /** Goes on after it hung. */
  void goOn();

  /**
   * Says something that nobody can read to whoever listens, once. Streams are wanted already.
   *
   * @throws IOException where it cannot
   */
  void garble() throws IOException;

  /**
   * What it can say; the first is said again and again while something is waited for. It should say as much as it can,
   * with units and frames of the framework that differ from those expected.
   *
   * @return at least one
   */
  List<Sample> samples();

  /**
   * Says something once, to whoever asks for it; to nobody while it is away or hangs.
   *
   * @param sample one of {@link #samples}
   * @throws IOException where it cannot
   */
  void say(Sample sample) throws IOException;

  /**
   * How many ask for a stream now, as the robot sees it.
   *
   * @param sample one of {@link #samples}
   * @return how many
   */
  int listeners(Sample sample);

  /**
   * The port by which it is moved.
   *
   * @return its name
   */
  String motionPort();

  /**
   * A motion that it understands, with a different number in each field that the framework has.
   *
   * @return not zero, in SI units
   */
  Motion<?> motion();

  /**
   * What it was told to do by that port's means, whoever did it, since this peer was made.
   *
   * @return in SI units, in order
   */
  List<Data> heard();

  /**
   * What the framework has listed: nodes, topics, subscriptions, open devices.
   *
   * @return a word for each
   */
  Set<String> registrations();

  /**
   * How many links to robot interfaces are open, as the robot sees it.
   *
   * @return how many
   */
  int links();

  /**
   * How long to wait for what shall happen. Machines are slow sometimes, and links are tried again after some seconds.
   *
   * @return a minute
   */
  default Duration patience() {
    return Duration.ofMinutes(1);
  }

  /** Ends everything; called once. */
  @Override
  void close();
}
