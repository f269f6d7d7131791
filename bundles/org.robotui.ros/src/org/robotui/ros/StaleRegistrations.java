package org.robotui.ros;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.robotui.ros.internal.node.StaleRegistrationCleaner;

/**
 * What killed processes left at masters. A node that was given a folder ({@link NodeOptions#withRecords}) keeps a note
 * of itself there until the master forgot it; a later process removes what is left of those whose process is gone.
 */
public final class StaleRegistrations {

  /**
   * What became of the notes of a folder.
   *
   * @param nodes the names of the nodes whose registrations were removed
   * @param complete whether there is nothing left to be tried again
   */
  public record Cleared(List<String> nodes, boolean complete) {

    /**
     * Copies the list.
     *
     * @param nodes the names
     * @param complete whether nothing is left
     */
    public Cleared {
      nodes = List.copyOf(nodes);
    }
  }

  private StaleRegistrations() {}

  /**
   * Removes the registrations of nodes that are noted in a folder, whose process on this machine is gone and which do
   * not answer. Nothing of other nodes is touched. Notes of masters that do not answer are kept for a week, to be tried
   * again. Waits for masters and for nodes that hang: not for threads that others wait for.
   *
   * @param folder the folder that was given to the nodes; need not exist
   * @param within no further node is looked at after this time; one takes some seconds at most
   * @return whose registrations were removed, and whether some are left because a master did not answer or time was
   * short
   * @throws IOException if the folder cannot be read
   */
  public static Cleared clear(Path folder, Duration within) throws IOException {
    return new StaleRegistrationCleaner(folder).run(within);
  }
}
