package org.robotui.install.internal;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.robotui.api.config.AtomicFile;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The update sites that a user has added: lines of a file, which other processes of the user write as well. */
final class KnownSites {
  private static final Logger LOG = LoggerFactory.getLogger(KnownSites.class);
  private static final String FILE = "update-sites.txt";

  private final Path file;

  KnownSites(Path folder) {
    file = folder.resolve(FILE);
  }

  synchronized List<URI> all() {
    return List.copyOf(read());
  }

  synchronized void add(URI site) {
    Set<URI> sites = read();
    if (sites.add(plain(site))) {
      write(sites);
    }
  }

  synchronized void remove(URI site) {
    Set<URI> sites = read();
    if (sites.remove(plain(site))) {
      write(sites);
    }
  }

  /** A site is a folder: with a slash at the end or without, it is the same. */
  static URI plain(URI site) {
    return URI.create(site.toString().replaceAll("(?<!/)/+$", ""));
  }

  private Set<URI> read() {
    Set<URI> sites = new LinkedHashSet<>();
    if (!Files.exists(file)) {
      return sites;
    }
    try {
      for (String line : Files.readAllLines(file)) {
        if (!line.isBlank()) {
          sites.add(plain(URI.create(line.strip())));
        }
      }
    } catch (IOException | IllegalArgumentException e) {
      LOG.warn("{} cannot be read, so that update sites in it are not known: {}", file, e.toString());
    }
    return sites;
  }

  private void write(Set<URI> sites) {
    String text = sites.stream().map(site -> site + "\n").collect(Collectors.joining());
    try {
      Files.createDirectories(file.getParent());
      AtomicFile.writePrivate(file, text);
    } catch (IOException e) {
      LOG.warn("{} cannot be written, so that update sites are not remembered: {}", file, e.toString());
    }
  }
}
