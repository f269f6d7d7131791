package org.robotui.workbench.internal;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Properties;
import org.robotui.api.config.AtomicFile;
import org.robotui.api.config.UserFolder;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** What the workbench keeps from one run to the next. A file that cannot be read or written is no reason to stop. */
public final class UserState {
  private static final Logger LOG = LoggerFactory.getLogger(UserState.class);
  private static final String FILE = "workbench.properties";

  private final Path folder;
  private final Properties values = new Properties();

  /** Reads what was kept in a folder. */
  public UserState(Path folder) {
    this.folder = folder;
    read();
  }

  /** The folder of this user: a system property, else what the XDG base directories say. */
  public static Path usualFolder() {
    return UserFolder.state(System.getProperties(), System.getenv());
  }

  /** A value, if it was kept. */
  public Optional<String> get(String name) {
    return Optional.ofNullable(values.getProperty(name));
  }

  /** Keeps a value; the file is small and written at once. */
  public void put(String name, String value) {
    if (!value.equals(values.setProperty(name, value))) {
      write();
    }
  }

  /** The folder in which it is kept. */
  public Path folder() {
    return folder;
  }

  private void read() {
    Path file = folder.resolve(FILE);
    if (Files.exists(file)) {
      try (InputStream in = Files.newInputStream(file)) {
        values.load(in);
      } catch (IOException | IllegalArgumentException e) {
        LOG.warn("{} cannot be read, so that the usual values are taken: {}", file, e.toString());
      }
    }
  }

  private void write() {
    Path file = folder.resolve(FILE);
    try {
      AtomicFile.writePrivate(file, out -> values.store(out, null));
    } catch (IOException e) {
      LOG.warn("{} cannot be written, so that what you change is kept for this run only: {}", file, e.toString());
    }
  }
}
