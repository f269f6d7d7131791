/** Values as they should be, and as broken and hostile programs send them, shown in views until they are painted. */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.testkit.values;
