use ethercrab as _; use futures_lite as _; use devc_generated as _;
