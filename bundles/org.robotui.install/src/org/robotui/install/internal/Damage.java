package org.robotui.install.internal;

import java.util.Arrays;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.eclipse.core.runtime.IStatus;
import org.eclipse.equinox.p2.core.ProvisionException;

/** Finds in what p2 answers that a file is not what its site has announced. */
final class Damage {
  private static final Pattern SUM = Pattern.compile("(?i)\\b(checksum|digest|md5|sha-\\d+)\\b");
  private static final Pattern KEY = Pattern.compile("osgi\\.bundle,([^,\\s]+),([\\w.-]*\\w)");

  private Damage() {}

  /** The sentence about it, where that is what has failed. */
  static Optional<String> in(IStatus status) {
    if (all(status).noneMatch(Damage::isOfSum)) {
      return Optional.empty();
    }
    String file = all(status).flatMap(each -> KEY.matcher(each.getMessage()).results())
        .map(found -> found.group(1) + " " + found.group(2)).findFirst().orElse("A file");
    return Optional.of(file + " is not what the site has announced: its checksum is another one. Nothing was changed."
        + " The file was damaged on its way or exchanged on the site; ask who keeps the site.");
  }

  private static boolean isOfSum(IStatus status) {
    return status.getCode() == ProvisionException.ARTIFACT_MD5_NOT_MATCH || SUM.matcher(status.getMessage()).find();
  }

  private static Stream<IStatus> all(IStatus status) {
    Stream<IStatus> cause = status.getException() instanceof ProvisionException inner && inner.getStatus() != status
        ? all(inner.getStatus())
        : Stream.empty();
    return Stream.concat(Stream.of(status),
        Stream.concat(Arrays.stream(status.getChildren()).flatMap(Damage::all), cause));
  }
}
