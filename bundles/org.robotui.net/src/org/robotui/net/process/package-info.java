/** Other processes of this machine: which of them still run ({@link org.robotui.net.process.RunningProcess}). */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.net.process;
