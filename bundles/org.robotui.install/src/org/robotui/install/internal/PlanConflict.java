package org.robotui.install.internal;

import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.eclipse.core.runtime.IStatus;
import org.eclipse.equinox.internal.p2.director.Explanation;
import org.eclipse.equinox.internal.provisional.p2.director.PlannerStatus;
import org.eclipse.equinox.internal.provisional.p2.director.RequestStatus;
import org.eclipse.equinox.p2.metadata.IInstallableUnit;
import org.eclipse.equinox.p2.metadata.IRequirement;

/** Why p2 finds no way, in sentences: it names what needs what, from the unit that was asked for to what is missing. */
@SuppressWarnings("restriction") // p2 tells reasons as values in packages of its own only
final class PlanConflict {
  private static final Pattern REQUIREMENT =
      Pattern.compile("([^;\\s]+); (\\S+) ([\\[(][^\\])]*[\\])]|[^,\\s]+).*");
  private static final Pattern RANGE = Pattern.compile("[\\[(]([^,]+),([^\\])]+)[\\])]");
  private static final Pattern WORDS = Pattern.compile("\\s*\\[?(.*?)]?\\s*", Pattern.DOTALL);

  private PlanConflict() {}

  /** The reasons of a plan that cannot be. */
  static String sentence(IStatus status) {
    Set<String> sentences = new LinkedHashSet<>();
    reasons(status).forEach(reason -> explain(reason).ifPresent(sentences::add));
    return sentences.isEmpty() ? leaves(status) : String.join(" ", sentences);
  }

  private static Set<Explanation> reasons(IStatus status) {
    Set<Explanation> all = new LinkedHashSet<>();
    if (status instanceof PlannerStatus planner) {
      RequestStatus request = planner.getRequestStatus();
      if (request != null && request.getExplanations() != null) {
        all.addAll(request.getExplanations());
      }
    } else {
      Arrays.stream(status.getChildren()).forEach(child -> all.addAll(reasons(child)));
    }
    return all;
  }

  private static Optional<String> explain(Explanation reason) {
    return switch (reason) {
      case Explanation.MissingIU missing -> Optional.of(name(missing.iu) + " needs " + needed(missing.req)
          + ", which is neither on the site nor installed.");
      case Explanation.Singleton singleton -> Optional.of("Only one of "
          + Arrays.stream(singleton.ius).map(PlanConflict::name).distinct().collect(Collectors.joining(" and "))
          + " can be installed.");
      default -> Optional.empty();
    };
  }

  /** p2 writes a requirement as a namespace, a name and a range of versions. */
  private static String needed(IRequirement requirement) {
    Matcher parts = REQUIREMENT.matcher(requirement.toString());
    if (!parts.matches()) {
      return requirement.toString();
    }
    return kind(parts.group(1)) + parts.group(2).replace(P2Work.SUFFIX, "") + version(parts.group(3));
  }

  private static String version(String range) {
    Matcher ends = RANGE.matcher(range);
    if (!ends.matches()) {
      return range.equals("0.0.0") ? "" : " " + range + " or newer";
    }
    return ends.group(1).equals(ends.group(2)) ? " " + ends.group(1)
        : " " + ends.group(1) + " or newer, but older than " + ends.group(2);
  }

  private static String kind(String namespace) {
    return switch (namespace) {
      case "java.package" -> "the package ";
      case "osgi.bundle" -> "the bundle ";
      case "org.eclipse.equinox.p2.iu" -> "";
      default -> namespace.toLowerCase(Locale.ROOT) + " ";
    };
  }

  private static String name(IInstallableUnit unit) {
    return P2Work.name(unit) + " " + unit.getVersion();
  }

  /** What p2 says itself, of that the most special. */
  private static String leaves(IStatus status) {
    if (status.getChildren().length == 0) {
      Matcher words = WORDS.matcher(status.getMessage());
      String message = words.matches() ? words.group(1) : status.getMessage();
      return message.endsWith(".") ? message : message + ".";
    }
    return Arrays.stream(status.getChildren()).filter(child -> child.getSeverity() >= IStatus.WARNING)
        .map(PlanConflict::leaves).distinct().collect(Collectors.joining(" "));
  }
}
