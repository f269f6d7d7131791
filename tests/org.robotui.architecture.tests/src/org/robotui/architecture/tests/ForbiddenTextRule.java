package org.robotui.architecture.tests;

import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** What must not stand in a bundle's sources: output past the log, and work put off. */
final class ForbiddenTextRule implements Rule {

  /** A text, and whether an application's entry may have it all the same. */
  private record Forbidden(Pattern text, boolean fineInApplications) {}

  private static final List<Forbidden> FORBIDDEN = List.of(
      new Forbidden(Pattern.compile("\\bSystem\\.(out|err)\\b"), true),
      new Forbidden(Pattern.compile("\\.printStackTrace\\(\\)"), false),
      new Forbidden(Pattern.compile("\\b(TODO|FIXME|XXX)\\b"), false));

  private static final Pattern APPLICATION = Pattern.compile("public static void main\\(|implements IApplication\\b");

  @Override
  public String statement() {
    return "no System.out outside of applications, no printStackTrace, no TODO";
  }

  @Override
  public Stream<Violation> violations(Repository repository) {
    return repository.bundles().stream().flatMap(bundle -> bundle.sources().stream())
        .flatMap(ForbiddenTextRule::violationsIn);
  }

  private static Stream<Violation> violationsIn(SourceFile source) {
    boolean application = APPLICATION.matcher(source.text()).find();
    return FORBIDDEN.stream()
        .filter(forbidden -> !(application && forbidden.fineInApplications()))
        .flatMap(forbidden -> forbidden.text().matcher(source.text()).results())
        .map(found -> new Violation(source.where(), "has " + found.group()));
  }
}
