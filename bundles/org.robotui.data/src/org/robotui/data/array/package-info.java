/** Arrays that nobody can change: bytes, floats and doubles, shared without a copy. */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.data.array;
