package org.robotui.api;

import java.nio.file.Path;
import java.util.concurrent.ThreadFactory;
import org.robotui.api.frame.FrameSink;
import org.robotui.api.link.LinkReporter;
import org.robotui.api.port.Offers;
import org.robotui.api.time.ClockSource;

/** What core gives to a robot interface. All of it is safe for all threads. */
public interface RficContext {
  /**
   * The robot that this instance speaks to; its frames belong to it.
   *
   * @return the robot's name
   */
  String robot();

  /**
   * The id of the instance within its RUIC, for messages.
   *
   * @return the id
   */
  String instance();

  /**
   * Where to offer ports.
   *
   * @return the offers
   */
  Offers offers();

  /**
   * Where to report the link.
   *
   * @return the reporter
   */
  LinkReporter link();

  /**
   * Where all threads of the instance come from, so that none is left unseen. They are platform daemon threads named
   * after the instance.
   *
   * @return the factory
   */
  ThreadFactory threads();

  /**
   * Where to report the robot's time.
   *
   * @return the clock source
   */
  ClockSource clock();

  /**
   * Where to report transforms.
   *
   * @return the sink
   */
  FrameSink frames();

  /**
   * Where the instance may keep files from one start to the next, for example what to tidy up after a crash.
   *
   * @return a folder that all instances of its type share; it may not exist yet
   */
  Path stateFolder();
}
