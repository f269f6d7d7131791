package org.robotui.rfic.lcm.internal;

import java.io.IOException;
import java.util.Map;
import org.robotui.testkit.rfic.Capability;

/** What carries messages between a robot of tests and its robot interface. */
interface LcmBus extends AutoCloseable {
  /** What robots on it cannot be tested for. */
  Map<Capability, String> lacks();

  /** Where the robot interface finds it. */
  String url();

  /** The robot comes; answers where its own programs find the bus. */
  String open() throws IOException;

  /** The robot goes: its programs are closed already. */
  void shut();

  /** Carries nothing from the robot and to it, and stays otherwise. */
  void hold();

  /** Carries again. */
  void goOn();

  /** Whether it carries nothing. */
  boolean holds();

  /** Puts bytes before those of the robot that are no messages. */
  void inject(byte[] bytes) throws IOException;

  /** How many are linked to the robot, where that is known. */
  int links();

  @Override
  void close();
}
