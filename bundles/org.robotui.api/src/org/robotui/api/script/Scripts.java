package org.robotui.api.script;

import java.util.List;
import java.util.Optional;
import java.nio.file.Path;
import java.util.function.Consumer;

/** Runs scripts: an OSGi service. Safe for all threads. */
public interface Scripts {
  /**
   * Begins a session.
   *
   * @param name as users read it where they see who has control, for example {@code the script patrol.js}
   * @param output is given what scripts print, a text at a time, on the thread of the script
   * @return the session; must be closed
   */
  ScriptSession open(String name, Consumer<String> output);

  /**
   * All functions that scripts can call now.
   *
   * @return by name
   */
  List<ScriptFunction> functions();

  /**
   * Lets other programs of this user run scripts by a socket, until the process ends or the result is closed.
   *
   * @param folder of the sockets of all processes of this user; need not exist
   * @return the socket, or none where it cannot be made, which is logged
   */
  Optional<Door> listen(Path folder);

  /**
   * Writes down what users do from now on, such as opening views or moving the timeline, as lines of a script that does
   * the same. Between them it waits as long as the user did. What moves robots continuously is not written down.
   *
   * @param line is given each line, on a thread of its own
   * @return ends it when closed
   */
  ActionRecording record(Consumer<String> line);

  /** What users do is being written down. */
  interface ActionRecording extends AutoCloseable {
    /** Ends it; lines of what was done before are given first. Waits for a moment. */
    @Override
    void close();
  }

  /** Where other programs of this user reach this process. */
  interface Door extends AutoCloseable {
    /**
     * The socket.
     *
     * @return its file
     */
    Path file();

    /** Ends it, and the sessions of those who came by it. */
    @Override
    void close();
  }
}
