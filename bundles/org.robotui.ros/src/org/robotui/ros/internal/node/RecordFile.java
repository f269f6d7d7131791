package org.robotui.ros.internal.node;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Keeps the record of one node on disk, if its owner gave it a folder for that. A disk that fails is no reason not to
 * run.
 */
final class RecordFile {

  private static final Logger LOG = LoggerFactory.getLogger(RecordFile.class);

  private final NodeRecord record;
  private final Optional<Path> file;
  private final SortedSet<String> parameters = new TreeSet<>();

  RecordFile(Optional<Path> folder, NodeRecord record, int port) {
    this.record = record;
    file = folder.map(path -> path.resolve("node-" + record.owner().process().pid() + "-" + port + NodeRecord.SUFFIX));
  }

  /** Before the master hears of the node for the first time. */
  void write() {
    file.ifPresent(path -> {
      try {
        Files.createDirectories(path.getParent());
        record.withParameters(parameters()).write(path);
      } catch (IOException e) {
        LOG.warn("{}: no record can be kept, a kill would leave its registrations at the master: {}", record.node(),
            e.toString());
      }
    });
  }

  private synchronized List<String> parameters() {
    return List.copyOf(parameters);
  }

  /** Before the node listens to a parameter. */
  void parameter(String key) {
    boolean added;
    synchronized (this) {
      added = parameters.add(key);
    }
    if (added) {
      write();
    }
  }

  /** When the master knows nothing of the node any more. */
  void delete() {
    file.ifPresent(path -> {
      try {
        Files.deleteIfExists(path);
      } catch (IOException e) {
        LOG.warn("{}: its record cannot be removed: {}", record.node(), e.toString());
      }
    });
  }
}
