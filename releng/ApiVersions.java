import com.sun.source.tree.ClassTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.MethodTree;
import com.sun.source.tree.ModifiersTree;
import com.sun.source.tree.Tree;
import com.sun.source.tree.VariableTree;
import com.sun.source.util.JavacTask;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.jar.Manifest;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.lang.model.element.Modifier;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/**
 * Says which exported packages have changed without that their version says so: what is gone, or has another signature,
 * takes a new major version, what was added a new minor one. It reads the sources alone, so that nothing must be built.
 * A method that an interface has more counts as added: whether others implement that interface is for people to judge.
 *
 * <p>{@code java releng/ApiVersions.java BEFORE NOW} compares two checkouts, and ends with 1 where a version must be
 * raised ({@code ./robotui versions} calls it).
 */
public final class ApiVersions {

  private static final Pattern EXPORT = Pattern.compile("([\\w.]+);version=\"(\\d+)\\.(\\d+)\\.(\\d+)\"");

  private static final int MOST_SHOWN = 12;

  /** An exported package: its version, and what others can use of it, one line each. */
  private record Exported(int major, int minor, Set<String> members) {

    String version() {
      return major + "." + minor + ".0";
    }
  }

  private ApiVersions() {}

  public static void main(String[] arguments) throws IOException {
    Map<String, Exported> before = packages(Path.of(arguments[0]));
    Map<String, Exported> now = packages(Path.of(arguments[1]));
    List<String> faults = new ArrayList<>();
    now.forEach((name, here) -> Optional.ofNullable(before.get(name)).flatMap(old -> fault(name, old, here))
        .ifPresent(faults::add));
    faults.forEach(System.out::println);
    System.out.println(faults.isEmpty() ? now.size() + " exported packages: each version says what has changed"
        : faults.size() + " of " + now.size() + " exported packages need another version");
    System.exit(faults.isEmpty() ? 0 : 1);
  }

  private static Optional<String> fault(String name, Exported before, Exported now) {
    Set<String> gone = new TreeSet<>(before.members());
    gone.removeAll(now.members());
    Set<String> added = new TreeSet<>(now.members());
    added.removeAll(before.members());
    String was = name + " was " + before.version() + " and is " + now.version();
    if (!gone.isEmpty() && now.major() <= before.major()) {
      return Optional.of(was + "; it must be " + (before.major() + 1) + ".0.0, as this is gone:" + shown(gone));
    }
    boolean higher = now.major() > before.major() || now.minor() > before.minor();
    return added.isEmpty() || higher ? Optional.empty()
        : Optional.of(was + "; it must be " + before.major() + "." + (before.minor() + 1) + ".0, as this was added:"
            + shown(added));
  }

  private static String shown(Set<String> members) {
    String rest = members.size() > MOST_SHOWN ? "\n    and " + (members.size() - MOST_SHOWN) + " more" : "";
    return members.stream().limit(MOST_SHOWN).map(member -> "\n    " + member).collect(Collectors.joining()) + rest;
  }

  private static Map<String, Exported> packages(Path root) throws IOException {
    Map<String, Exported> all = new TreeMap<>();
    try (Stream<Path> bundles = Files.list(root.resolve("bundles"))) {
      for (Path bundle : bundles.filter(each -> Files.exists(each.resolve("META-INF/MANIFEST.MF"))).toList()) {
        Matcher exports = EXPORT.matcher(exports(bundle));
        while (exports.find()) {
          Path sources = bundle.resolve("src").resolve(exports.group(1).replace('.', '/'));
          all.put(exports.group(1), new Exported(Integer.parseInt(exports.group(2)), Integer.parseInt(exports.group(3)),
              Files.isDirectory(sources) ? members(sources) : Set.of()));
        }
      }
    }
    return all;
  }

  private static String exports(Path bundle) throws IOException {
    try (InputStream in = Files.newInputStream(bundle.resolve("META-INF/MANIFEST.MF"))) {
      return Optional.ofNullable(new Manifest(in).getMainAttributes().getValue("Export-Package")).orElse("");
    }
  }

  private static Set<String> members(Path folder) throws IOException {
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    Set<String> members = new TreeSet<>();
    try (Stream<Path> files = Files.list(folder);
        StandardJavaFileManager manager = compiler.getStandardFileManager(null, null, null)) {
      List<Path> sources =
          files.filter(f -> f.toString().endsWith(".java") && !f.endsWith("package-info.java")).toList();
      JavacTask task = (JavacTask) compiler.getTask(null, manager, null, List.of("-proc:none"), null,
          manager.getJavaFileObjectsFromPaths(sources));
      for (CompilationUnitTree unit : task.parse()) {
        unit.getTypeDecls().stream().filter(ClassTree.class::isInstance).map(ClassTree.class::cast)
            .filter(type -> isOpen(type.getModifiers(), false)).forEach(type -> type("", type, members));
      }
    }
    return members;
  }

  private static void type(String outer, ClassTree type, Set<String> members) {
    String name = outer + type.getSimpleName();
    members.add(type.getKind().name().toLowerCase(Locale.ROOT) + " " + name + parameters(type.getTypeParameters()));
    Optional.ofNullable(type.getExtendsClause()).ifPresent(above -> members.add(name + " extends " + above));
    type.getImplementsClause().forEach(above -> members.add(name + " implements " + above));
    if (type.getKind() == Tree.Kind.CLASS && !type.getModifiers().getFlags().contains(Modifier.FINAL)) {
      members.add(name + " may be extended");
    }
    if (type.getKind() == Tree.Kind.RECORD) {
      components(type).forEach(field -> members.add(name + "." + field.getName() + "(): " + field.getType()));
      members.add(name + named(components(type)));
    }
    boolean open = type.getKind() == Tree.Kind.INTERFACE || type.getKind() == Tree.Kind.ANNOTATION_TYPE;
    type.getMembers().forEach(member -> member(name, type, member, open, members));
  }

  private static void member(String owner, ClassTree type, Tree member, boolean open, Set<String> members) {
    switch (member) {
      case ClassTree inner when isOpen(inner.getModifiers(), open) -> type(owner + ".", inner, members);
      case MethodTree method when isCanonical(type, method) -> {}
      case MethodTree method when isMade(type, method) -> members.add(owner + named(method.getParameters().stream()));
      case MethodTree method when isOpen(method.getModifiers(), open) -> members.add(method(owner, method));
      case VariableTree field when isComponent(type, field) -> {}
      case VariableTree field when isOpen(field.getModifiers(), open) -> members.add(fixed(field.getModifiers()) + owner
          + "." + field.getName() + ": " + field.getType());
      default -> {}
    }
  }

  private static String method(String owner, MethodTree method) {
    String arguments = method.getParameters().stream().map(parameter -> parameter.getType().toString())
        .collect(Collectors.joining(", ", "(", ")"));
    String result = Optional.ofNullable(method.getReturnType()).map(type -> ": " + type).orElse("");
    return fixed(method.getModifiers()) + owner + "." + method.getName() + parameters(method.getTypeParameters())
        + arguments + result;
  }

  private static Stream<VariableTree> components(ClassTree type) {
    return type.getMembers().stream().filter(VariableTree.class::isInstance).map(VariableTree.class::cast)
        .filter(field -> isComponent(type, field));
  }

  private static String named(Stream<? extends VariableTree> variables) {
    return variables.map(variable -> variable.getType() + " " + variable.getName())
        .collect(Collectors.joining(", ", "(", ")"));
  }

  private static String parameters(List<? extends Tree> types) {
    return types.isEmpty() ? "" : types.stream().map(Tree::toString).collect(Collectors.joining(", ", "<", ">"));
  }

  private static String fixed(ModifiersTree modifiers) {
    return modifiers.getFlags().contains(Modifier.STATIC) ? "static " : "";
  }

  /** Whether it is what a record has in any case, written or not. */
  private static boolean isCanonical(ClassTree type, MethodTree method) {
    return type.getKind() == Tree.Kind.RECORD && method.getName().contentEquals("<init>")
        && types(method.getParameters().stream()).equals(types(components(type)));
  }

  /** Whether it makes a record of fewer things: one that was extended can still be made as before. */
  private static boolean isMade(ClassTree type, MethodTree method) {
    return type.getKind() == Tree.Kind.RECORD && method.getName().contentEquals("<init>")
        && isOpen(method.getModifiers(), false);
  }

  private static List<String> types(Stream<? extends VariableTree> variables) {
    return variables.map(variable -> variable.getType().toString()).toList();
  }

  /** Components of a record stand in the tree as fields that are private and not static. */
  private static boolean isComponent(ClassTree type, VariableTree field) {
    return type.getKind() == Tree.Kind.RECORD && !field.getModifiers().getFlags().contains(Modifier.STATIC);
  }

  /** Whether others can use it. Members of interfaces are open without saying so. */
  private static boolean isOpen(ModifiersTree modifiers, boolean otherwise) {
    Set<Modifier> flags = modifiers.getFlags();
    return flags.contains(Modifier.PUBLIC) || flags.contains(Modifier.PROTECTED)
        || otherwise && !flags.contains(Modifier.PRIVATE);
  }
}
