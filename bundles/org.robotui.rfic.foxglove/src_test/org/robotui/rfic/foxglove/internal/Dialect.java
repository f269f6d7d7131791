package org.robotui.rfic.foxglove.internal;

import java.nio.ByteBuffer;
import java.util.List;
import org.robotui.data.Data;
import org.robotui.testkit.rfic.Sample;

/** How a server of tests speaks: encodings and schemas of what it offers and takes. */
interface Dialect {
  List<String> capabilities();

  List<String> encodings();

  /** Offers a channel for each sample, with the number of the sample. */
  void offer(FoxgloveServer server);

  List<Sample> samples();

  /** What is said on a channel. */
  ByteBuffer message(int channel);

  /** What a client published, as the robot understands it. */
  Data heard(FoxgloveServer.Said said);
}
