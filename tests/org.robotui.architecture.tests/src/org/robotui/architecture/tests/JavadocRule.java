package org.robotui.architecture.tests;

import com.sun.source.tree.ClassTree;
import com.sun.source.tree.MethodTree;
import com.sun.source.tree.ModifiersTree;
import com.sun.source.tree.Tree;
import com.sun.source.tree.VariableTree;
import com.sun.source.util.TreePath;
import com.sun.source.util.TreePathScanner;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import javax.lang.model.element.Modifier;

/** Whatever another bundle can see is explained. The compiler checks that the explanation is well-formed. */
final class JavadocRule implements Rule {

  @Override
  public String statement() {
    return "everything public in an exported package has Javadoc";
  }

  @Override
  public Stream<Violation> violations(Repository repository) {
    return repository.bundles().stream().flatMap(bundle -> bundle.sources().stream()
        .filter(source -> bundle.manifest().exportedPackages().contains(source.folderPackage()))
        .flatMap(JavadocRule::undocumented));
  }

  private static Stream<Violation> undocumented(SourceFile source) {
    ParsedSource parsed = source.parsed();
    Finder finder = new Finder(parsed);
    finder.scan(parsed.unit(), null);
    return finder.names.build().map(name -> new Violation(source.where(), name + " has no Javadoc"));
  }

  /** Walks through what is visible from outside only. */
  private static final class Finder extends TreePathScanner<Void, Void> {

    private final ParsedSource parsed;
    private final Stream.Builder<String> names = Stream.builder();

    Finder(ParsedSource parsed) {
      this.parsed = parsed;
    }

    @Override
    public Void visitClass(ClassTree type, Void none) {
      if (!isVisible(type.getModifiers())) {
        return null;
      }
      require(type.getSimpleName().toString());
      return super.visitClass(type, none);
    }

    @Override
    public Void visitMethod(MethodTree method, Void none) {
      if (isVisible(method.getModifiers()) && !isInherited(method) && !isCanonicalConstructor(method)) {
        require(method.getName().contentEquals("<init>") ? "a constructor" : method.getName().toString());
      }
      return null;
    }

    @Override
    public Void visitVariable(VariableTree field, Void none) {
      boolean ofType = getCurrentPath().getParentPath().getLeaf() instanceof ClassTree;
      if (ofType && isVisible(field.getModifiers())) {
        require(field.getName().toString());
      }
      return null;
    }

    private void require(String name) {
      TreePath path = getCurrentPath();
      if (parsed.trees().getDocComment(path) == null) {
        names.add(name);
      }
    }

    private boolean isVisible(ModifiersTree modifiers) {
      Set<Modifier> flags = modifiers.getFlags();
      boolean inInterface = getCurrentPath().getParentPath().getLeaf() instanceof ClassTree outer
          && outer.getKind() == Tree.Kind.INTERFACE && !flags.contains(Modifier.PRIVATE);
      return inInterface || flags.contains(Modifier.PUBLIC) || flags.contains(Modifier.PROTECTED);
    }

    private static boolean isInherited(MethodTree method) {
      return method.getModifiers().getAnnotations().stream()
          .anyMatch(annotation -> annotation.getAnnotationType().toString().equals("Override"));
    }

    /** A record is explained by its own comment. */
    private boolean isCanonicalConstructor(MethodTree method) {
      return getCurrentPath().getParentPath().getLeaf() instanceof ClassTree type && type.getKind() == Tree.Kind.RECORD
          && method.getName().contentEquals("<init>") && (method.getParameters().size() == components(type));
    }

    private static long components(ClassTree type) {
      List<? extends Tree> members = type.getMembers();
      return members.stream().filter(VariableTree.class::isInstance).map(VariableTree.class::cast)
          .filter(field -> !field.getModifiers().getFlags().contains(Modifier.STATIC)).count();
    }
  }
}
