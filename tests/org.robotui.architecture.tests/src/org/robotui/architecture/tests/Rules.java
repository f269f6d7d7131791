package org.robotui.architecture.tests;

import java.util.List;

/** All rules of this repository. */
final class Rules {

  static final List<Rule> ALL = List.of(
      new LayerRule(), new BuildOrderRule(), new ReservedPackagesRule(), new ComponentIsolationRule(), new ExportRule(),
      new NamingRule(), new SharedNameRule(),
      new LazyComponentsRule(), new FeatureRule(), new StartLevelRule(), new ArchitectureDocumentRule(),
      new WalkRule(),
      new JavadocRule(), new SizeRule(),
      new ForbiddenTextRule(), new PathRule(), new IdeRule());

  private Rules() {}
}
