package org.robotui.yarp.internal;

import java.util.Optional;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.wire.YarpMessage;

/** What a door is the door of: a port, or a name server. Called by the threads of its connections. */
public interface Served {
  /** How it is called. */
  String name();

  /** Data by tcp or fast_tcp; a reply, where there is one. */
  Optional<Bottle> data(String from, YarpMessage message);

  /** A line of data by the text carrier; the lines of the answer with their ends. */
  String text(String from, String line);

  /** A command that is a line by itself ({@code /target}, {@code !target}, {@code *}); the lines of the answer. */
  String command(String line);

  /** A line of administration; the line of the answer. */
  String admin(String line);

  /** A question to a name server, which ends the connection; empty where this is none. */
  Optional<String> names(String line);

  /** Somebody has connected, by another carrier than text. */
  void opened(String from);

  /** Something of who is connected did not arrive, or not as it was said. */
  void lost(String from, String reason);

  /** Who was connected is so no more. */
  void ended(String from, String reason);
}
