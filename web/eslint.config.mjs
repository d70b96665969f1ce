import tseslint from "typescript-eslint";

export default tseslint.config(...tseslint.configs.strict, ...tseslint.configs.stylistic, {
  rules: {
    eqeqeq: "error",
    "prefer-const": "error",
    "@typescript-eslint/no-non-null-assertion": "off",
  },
});
